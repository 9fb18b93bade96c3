// The wheel over a picture zooms it.

/** Calls back with the factor that each turn of the wheel over the canvas zooms by. */
export function zoomByWheel(
  canvas: HTMLCanvasElement,
  zoom: (factor: number, event: WheelEvent) => void,
): void {
  const turn = (event: WheelEvent): void => {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    // A pinch on a trackpad arrives as a wheel with Ctrl and small steps.
    const speed = event.ctrlKey ? 0.01 : 0.0016;
    zoom(Math.exp(-event.deltaY * lines * speed), event);
  };
  canvas.addEventListener("wheel", turn, { passive: false });
}
