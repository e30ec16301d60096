import { useId } from 'preact/hooks'
import { readArea } from '../../area-file.ts'
import type { StudioArea } from '../../document/document.ts'
import { Drivers } from '../drivers/drivers.tsx'
import type { PanelModel } from '../model.ts'
import { PaintControls } from '../painting/painting.tsx'

const COMBINATIONS: readonly { value: StudioArea['combine']; label: string }[] = [
  { value: 'sum', label: 'Added' },
  { value: 'max', label: 'Maximum' },
]

export function ChosenArea({ model }: { model: PanelModel }) {
  const { areas, actions } = model
  const area = areas.chosen.value
  const id = useId()
  if (!area) return null
  const { name, activation } = area
  return (
    <section class="chosen-area" aria-label={`Area ${name}`}>
      <div class="settings">
        <div class="setting">
          <label for={`${id}-name`}>Name</label>
          <input
            id={`${id}-name`}
            type="text"
            autocomplete="off"
            spellcheck={false}
            value={name}
            onChange={({ currentTarget }) => {
              areas.rename(name, currentTarget.value)
              // If another area has the new name, show the old name again.
              currentTarget.value = areas.chosen.peek()?.name ?? name
            }}
          />
        </div>
        <LayerChoice area={area} model={model} />
        <div class="setting">
          <label for={`${id}-combine`}>Overlap</label>
          <select
            id={`${id}-combine`}
            title="How this area combines with other areas of its layer"
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
      <div class="row number">
        <label for={`${id}-rest`} title="Activation while nothing else activates the area">
          At rest
        </label>
        <input
          id={`${id}-rest`}
          type="range"
          min="0"
          max="1"
          step="0.01"
          value={activation}
          style={{ '--value': activation }}
          onInput={({ currentTarget }) => areas.set(name, { activation: currentTarget.valueAsNumber })}
          onChange={() => areas.settle()}
        />
        <output for={`${id}-rest`} aria-live="off">
          {activation.toFixed(2)}
        </output>
      </div>
      <div class="add">
        <button type="button" onClick={() => areas.recordPose(name, actions.pose())}>
          This pose fully shows this area
        </button>
        <button type="button" onClick={() => areas.duplicate(name)}>
          Duplicate
        </button>
        <button
          type="button"
          title="Add or replace the mirror image of this area"
          onClick={() => areas.mirror(name, (weights) => model.painting.mirrored(weights))}
        >
          Mirror
        </button>
        <FromImage name={name} model={model} />
        <button type="button" onClick={() => areas.remove(name)}>
          Delete
        </button>
      </div>
      <PaintControls painting={model.painting} />
      <Drivers model={model} area={name} />
    </section>
  )
}

/** File input that replaces the weights of an area by an image. */
function FromImage({ name, model: { areas, actions } }: { name: string; model: PanelModel }) {
  const fill = async (file: File) => {
    const { weights } = await readArea(file, areas.isPaper.peek() ? 'paper' : 'weight')
    areas.fill(name, weights)
  }
  return (
    <label class="file" title="Replace the painted weights by a gray image">
      <input
        type="file"
        accept="image/*"
        aria-label={`Fill ${name} from an image`}
        onChange={({ currentTarget }) => {
          const [file] = currentTarget.files!
          if (file) actions.attempt(() => fill(file))
          currentTarget.value = ''
        }}
      />
      <span>From image…</span>
    </label>
  )
}

function LayerChoice({ area, model: { session, areas } }: { area: StudioArea; model: PanelModel }) {
  const id = useId()
  const layers = session.document.value?.layers ?? []
  return (
    <div class="setting">
      <label for={id}>Layer</label>
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
