import { BRUSH, PAINT } from '../../labels/brushes.ts'
import { PLACES, TOOLS } from '../../labels/page.ts'
import { BRUSH_MODES, type Brush } from '../../paint/brush.ts'
import type { Painting } from '../../tools/painting.ts'
import { Choice } from '../controls/choice.tsx'
import { NumberSlider } from '../controls/number-slider.tsx'
import type { PanelModel } from '../model.ts'
import { BrushSize } from './brush-size.tsx'
import { PaintChecks } from './paint-checks.tsx'
import { PolygonControls } from './polygon.tsx'

const MODES = BRUSH_MODES.map((value) => ({ value, label: PAINT[value] }))

/** Minimum, maximum and step of the slider for the diameter, millimetres. With keys, users can exceed this range. */
const SIZES = [1, 80, 0.5] as const

/** Settings of the brush or the polygon. */
export function BrushSettings({ model: { painting } }: { model: PanelModel }) {
  const isBrush = painting.shape.value === 'brush'
  return (
    <section class="brush" aria-label={isBrush ? PLACES.brush : TOOLS.polygon}>
      {isBrush ? <BrushControls painting={painting} /> : <PolygonControls painting={painting} />}
    </section>
  )
}

function BrushControls({ painting }: { painting: Painting }) {
  const brush = painting.brush.value
  const change = (fields: Partial<Brush>) => {
    painting.brush.value = { ...brush, ...fields }
  }
  return (
    <>
      <Choice label={PLACES.brush} options={MODES} value={brush.mode} onChange={(mode) => change({ mode })} />
      <BrushSize
        label={BRUSH.size}
        radius={brush.radius}
        range={SIZES}
        onChange={(radius) => change({ radius })}
      />
      <NumberSlider
        label={BRUSH.softness}
        range={[0, 1, 0.01]}
        value={brush.softness}
        onMove={(softness) => change({ softness })}
      />
      <NumberSlider
        label={PAINT.flow}
        range={[0.01, 1, 0.01]}
        value={brush.flow}
        onMove={(flow) => change({ flow })}
      />
      <PaintChecks painting={painting} />
      <p class="hint">{PAINT.hint}</p>
    </>
  )
}
