import { PAINT, POLYGON } from '../../labels/brushes.ts'
import { TOOLS } from '../../labels/page.ts'
import type { Painting } from '../../tools/painting.ts'
import { Choice } from '../controls/choice.tsx'
import { NumberSlider } from '../controls/number-slider.tsx'
import { PaintChecks } from './paint-checks.tsx'

const MODES = [
  { value: 'add', label: PAINT.add },
  { value: 'remove', label: PAINT.remove },
] as const

/** Settings of polygons, and buttons that replace keys on touch screens. */
export function PolygonControls({ painting }: { painting: Painting }) {
  const { polygon, brush } = painting
  const count = polygon.count.value
  return (
    <>
      <Choice
        label={TOOLS.polygon}
        options={MODES}
        value={brush.value.mode === 'remove' ? 'remove' : 'add'}
        onChange={(mode) => {
          brush.value = { ...brush.peek(), mode }
        }}
      />
      <NumberSlider
        label={POLYGON.feather}
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
          {POLYGON.close}
        </button>
        <button type="button" disabled={count === 0} onClick={() => polygon.clear()}>
          {POLYGON.clear}
        </button>
      </div>
      <p class="hint">{POLYGON.hint}</p>
    </>
  )
}
