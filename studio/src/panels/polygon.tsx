import type { PolygonPainting } from '../tools/polygon-painting.ts'
import { NumberSlider } from './number-slider.tsx'

/** How a polygon is painted, and what closes it for a finger. */
export function PolygonControls({ polygon }: { polygon: PolygonPainting }) {
  const count = polygon.count.value
  const setFeather = (feather: number) => {
    polygon.feather.value = feather
  }
  return (
    <>
      <NumberSlider
        label="Feather, mm"
        range={[0, 30, 0.5]}
        value={polygon.feather.value}
        onMove={setFeather}
        onRest={setFeather}
      />
      <div class="add">
        <button type="button" disabled={count < 3} onClick={() => polygon.tool.close()}>
          Close polygon
        </button>
        <button type="button" disabled={count === 0} onClick={() => polygon.tool.clear()}>
          Clear
        </button>
      </div>
      <p class="hint">
        Click points on the face. Enter, or a click on the first point, closes the polygon; Backspace takes the
        last point back, Esc all of them.
      </p>
    </>
  )
}
