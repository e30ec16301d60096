import { useId } from 'preact/hooks'
import { readArea } from '../../area-file.ts'
import type { StudioArea } from '../../document/document.ts'
import { regionLabel } from '../../labels/names.ts'
import { PLACES } from '../../labels/page.ts'
import { REGION, regionLabels } from '../../labels/regions.ts'
import { FileButton } from '../controls/file-button.tsx'
import { NumberSlider } from '../controls/number-slider.tsx'
import { TextField } from '../controls/text-field.tsx'
import type { PanelModel } from '../model.ts'

const COMBINATIONS: readonly { value: StudioArea['combine']; label: string }[] = [
  { value: 'sum', label: REGION.added },
  { value: 'max', label: REGION.maximum },
]

/** Settings of the chosen area, which the page calls a region. */
export function ChosenArea({ model }: { model: PanelModel }) {
  const { areas } = model
  const area = areas.chosen.value
  const id = useId()
  if (!area) return null
  const { name, activation } = area
  return (
    <section class="chosen-area" aria-label={`${regionLabel(name)} ${name}`}>
      <NumberSlider
        label={REGION.rest}
        range={[0, 1, 0.01]}
        value={activation}
        onMove={(next) => areas.set(name, { activation: next })}
        onRest={() => areas.settle()}
      />
      <div class="add">
        <button type="button" onClick={() => areas.duplicate(name)}>
          {REGION.duplicate}
        </button>
        <button
          type="button"
          title={REGION.mirrorHint}
          onClick={() => areas.mirror(name, (weights) => model.painting.mirrored(weights))}
        >
          {REGION.mirror}
        </button>
        <FromImage name={name} model={model} />
        <button type="button" onClick={() => areas.remove(name)}>
          {REGION.remove}
        </button>
      </div>
      <details>
        <summary>{PLACES.advanced}</summary>
        <div class="settings">
          <TextField label={REGION.name} value={name} onChange={(next) => areas.rename(name, next)} />
          <LayerChoice area={area} model={model} />
          <div class="setting">
            <label for={id}>{REGION.overlap}</label>
            <select
              id={id}
              title={REGION.overlapHint}
              value={area.combine}
              onChange={({ currentTarget }) =>
                areas.set(name, { combine: currentTarget.value as StudioArea['combine'] })
              }
            >
              {COMBINATIONS.map(({ value, label }) => (
                <option key={value} value={value}>
                  {label}
                </option>
              ))}
            </select>
          </div>
        </div>
      </details>
    </section>
  )
}

/** File input that replaces the weights of an area by an image. */
function FromImage({ name, model: { areas, actions } }: { name: string; model: PanelModel }) {
  const fill = async (file: File) => {
    const { weights } = await readArea(file, areas.convention)
    areas.fill(name, weights)
  }
  return (
    <FileButton
      label={regionLabels(name).fromImage}
      title={REGION.fromImageHint}
      accept="image/*"
      onChoose={([file]) => actions.attempt(() => fill(file))}
    >
      {REGION.fromImage}
    </FileButton>
  )
}

function LayerChoice({ area, model: { session, areas } }: { area: StudioArea; model: PanelModel }) {
  const id = useId()
  const layers = session.document.value?.layers ?? []
  return (
    <div class="setting">
      <label for={id}>{REGION.layer}</label>
      <select
        id={id}
        value={area.layer}
        onChange={({ currentTarget }) => areas.set(area.name, { layer: currentTarget.value })}
      >
        {layers.map(({ name }) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
    </div>
  )
}
