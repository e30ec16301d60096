import { readArea } from '../../area-file.ts'
import { BRUSH, SCULPT } from '../../labels/brushes.ts'
import { TOOLS } from '../../labels/page.ts'
import { SCULPT_MODES } from '../../paint/brush.ts'
import type { SculptSettings as Settings } from '../../tools/sculpt-settings.ts'
import { Choice } from '../controls/choice.tsx'
import { FileButton } from '../controls/file-button.tsx'
import { NumberSlider } from '../controls/number-slider.tsx'
import type { PanelModel } from '../model.ts'
import { BrushSize } from './brush-size.tsx'

const MODES = SCULPT_MODES.map((value) => ({ value, label: SCULPT[value] }))

/** Minimum, maximum and step of the sliders for the diameter and the height, millimetres. */
const SIZES = [1, 40, 0.5] as const
const HEIGHTS = [0.05, 5, 0.05] as const

/** Settings of the brush that sculpts heights. */
export function SculptSettings({ model: { sculpting, actions } }: { model: PanelModel }) {
  const { mode, radius, softness, height, strength, stamp } = sculpting.settings.value
  const change = (fields: Partial<Settings>) => {
    sculpting.settings.value = { ...sculpting.settings.peek(), ...fields }
  }
  return (
    <section class="brush" aria-label={TOOLS.sculpt}>
      <Choice
        label={TOOLS.sculpt}
        options={MODES}
        value={mode}
        columns={2}
        onChange={(value) => change({ mode: value })}
      />
      <BrushSize
        label={BRUSH.size}
        radius={radius}
        range={SIZES}
        onChange={(next) => change({ radius: next })}
      />
      {mode === 'raise' || mode === 'lower' ? (
        <NumberSlider
          label={SCULPT.height}
          range={HEIGHTS}
          value={height}
          onMove={(value) => change({ height: value })}
        />
      ) : (
        <NumberSlider
          label={SCULPT.strength}
          range={[0.05, 1, 0.05]}
          value={strength}
          onMove={(value) => change({ strength: value })}
        />
      )}
      <NumberSlider
        label={BRUSH.softness}
        range={[0, 1, 0.01]}
        value={softness}
        onMove={(value) => change({ softness: value })}
      />
      <div class="add">
        <FileButton
          label={SCULPT.stamp}
          title={SCULPT.stampTitle}
          accept="image/png,image/jpeg,image/webp"
          onChoose={([file]) =>
            actions.attempt(async () => {
              const { name, weights } = await readArea(file, 'weight')
              change({ stamp: { name, image: weights } })
            })
          }
        >
          {stamp?.name ?? SCULPT.stamp}
        </FileButton>
        {stamp && (
          <button
            type="button"
            class="remove"
            aria-label={SCULPT.removeStamp}
            title={SCULPT.removeStamp}
            onClick={() => change({ stamp: null })}
          >
            ×
          </button>
        )}
      </div>
      <p class="hint">{SCULPT.hint}</p>
    </section>
  )
}
