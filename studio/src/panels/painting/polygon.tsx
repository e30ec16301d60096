import type { Painting } from '../../tools/painting.ts'
import { Choice } from '../controls/choice.tsx'
import { NumberSlider } from '../controls/number-slider.tsx'
import { PaintChecks } from './paint-checks.tsx'

const MODES = [
  { value: 'add', label: 'Add' },
  { value: 'remove', label: 'Remove' },
] as const

/** Settings of polygons, and buttons that replace keys on touch screens. */
export function PolygonControls({ painting }: { painting: Painting }) {
  const { polygon, brush } = painting
  const count = polygon.count.value
  return (
    <>
      <Choice
        label="Polygon"
        options={MODES}
        value={brush.value.mode === 'remove' ? 'remove' : 'add'}
        onChange={(mode) => {
          brush.value = { ...brush.peek(), mode }
        }}
      />
      <NumberSlider
        label="Feather"
        range={[0, 30, 0.5]}
        value={polygon.feather.value}
        text={`${polygon.feather.value} mm`}
        onMove={(feather) => {
          polygon.feather.value = feather
        }}
      />
      <PaintChecks painting={painting} />
      <div class="add">
        <button type="button" disabled={count < 3} onClick={() => polygon.close()}>
          Close polygon
        </button>
        <button type="button" disabled={count === 0} onClick={() => polygon.clear()}>
          Clear
        </button>
      </div>
      <p class="hint">
        Click points on the face or on its texture. Enter, or a click on the first point, closes the polygon;
        Backspace takes the last point back, Esc all of them.
      </p>
    </>
  )
}
