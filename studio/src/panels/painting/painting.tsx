import { BRUSH_MODES, type Brush } from '../../paint/brush.ts'
import { PAINT_SHAPES, type Painting } from '../../tools/painting.ts'
import { Choice } from '../controls/choice.tsx'
import { NumberSlider } from '../controls/number-slider.tsx'
import { PaintChecks } from './paint-checks.tsx'
import { PolygonControls } from './polygon.tsx'

const titled = <T extends string>(value: T) => ({ value, label: value[0].toUpperCase() + value.slice(1) })
const SHAPES = PAINT_SHAPES.map(titled)
const MODES = BRUSH_MODES.map(titled)

/** Minimum, maximum and step of the slider for the diameter, millimetres. With keys, users can exceed this range. */
const SIZES = [1, 80, 0.5] as const

/** Button that starts painting, and the settings of its tools. */
export function PaintControls({ painting }: { painting: Painting }) {
  const isOn = painting.area.value !== null
  return (
    <>
      <button
        type="button"
        class="paint"
        aria-pressed={isOn}
        onClick={() => {
          painting.isOn = !isOn
        }}
      >
        Paint
      </button>
      {isOn && (
        <div class="brush">
          <Choice
            label="Tool"
            options={SHAPES}
            value={painting.shape.value}
            onChange={(shape) => {
              painting.shape.value = shape
            }}
          />
          {painting.shape.value === 'brush' ? (
            <BrushControls painting={painting} />
          ) : (
            <PolygonControls painting={painting} />
          )}
        </div>
      )}
    </>
  )
}

function BrushControls({ painting }: { painting: Painting }) {
  const brush = painting.brush.value
  const change = (fields: Partial<Brush>) => {
    painting.brush.value = { ...brush, ...fields }
  }
  return (
    <>
      <Choice label="Brush" options={MODES} value={brush.mode} onChange={(mode) => change({ mode })} />
      <NumberSlider
        label="Size"
        range={SIZES}
        value={2 * brush.radius}
        text={`${(2 * brush.radius).toFixed(brush.radius < 5 ? 1 : 0)} mm`}
        onMove={(size) => change({ radius: size / 2 })}
      />
      <NumberSlider
        label="Softness"
        range={[0, 1, 0.01]}
        value={brush.softness}
        onMove={(softness) => change({ softness })}
      />
      <NumberSlider
        label="Flow"
        range={[0.01, 1, 0.01]}
        value={brush.flow}
        onMove={(flow) => change({ flow })}
      />
      <PaintChecks painting={painting} />
      <p class="hint">
        Drag on the face. Alt, two fingers, or a drag beside the face move the camera. Keys: [ and ] for the
        size, X for add or remove, Esc to take a stroke back.
      </p>
    </>
  )
}
