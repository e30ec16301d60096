import type { ComponentChildren } from 'preact'
import { LINE } from '../labels/lines.ts'
import { PLACES } from '../labels/page.ts'
import { CARD } from '../labels/stage.ts'
import { NumberSlider } from '../panels/controls/number-slider.tsx'
import { Reasons } from '../panels/drivers/reasons.tsx'
import { LineSection } from '../panels/line-section.tsx'
import type { PanelModel } from '../panels/model.ts'
import { RegionCard } from './region-card.tsx'
import { type Selected, selectedIn } from './selected.ts'
import { isSmallPage } from './small-page.ts'
import { WhenQuestion } from './when-question.tsx'

/** Cards over the stage: the main values of the selected region or line, and the region under the pointer. */
export function Cards({ model }: { model: PanelModel }) {
  const { kind, name } = model.hovered.value ?? {}
  return (
    <>
      {!isSmallPage.value && <SelectionCard model={model} />}
      <FillCard fill={model.fill} />
      {kind === 'area' && name !== undefined && <Reasons area={name} model={model} />}
    </>
  )
}

/** Card of the selected region or line. On small pages, where it would cover the face, the inspector contains it. */
export function SelectionCard({ model }: { model: PanelModel }) {
  if (model.tools.mode.value === 'motion') return null
  const selected = selectedIn(model)
  if (selected.kind === 'region' && model.tools.mode.value === 'look')
    return (
      <Frame selected={selected} model={model}>
        <RegionCard area={selected.area!} model={model} />
      </Frame>
    )
  if (selected.kind !== 'line') return null
  return (
    <Frame selected={selected} model={model}>
      <LineCard model={model} />
    </Frame>
  )
}

/** Offer to fill a region with lines that the user has painted. */
function FillCard({ fill }: Pick<PanelModel, 'fill'>) {
  if (fill.offered.value === null) return null
  return (
    <section class="card" aria-label={CARD.fill}>
      <p class="hint" role="status">
        {CARD.noLines}
      </p>
      <div class="work">
        <button type="button" onClick={() => fill.fill()}>
          {CARD.fill}
        </button>
        <button type="button" onClick={() => fill.refuse()}>
          {CARD.notNow}
        </button>
      </div>
    </section>
  )
}

interface FrameProps {
  selected: Selected
  model: PanelModel
  children: ComponentChildren
}

function Frame({ selected: { label }, model: { actions }, children }: FrameProps) {
  return (
    <section class="card" aria-label={label}>
      <header>
        <h2>{label}</h2>
        <button
          type="button"
          class="dismiss"
          aria-label={PLACES.deselect}
          title={PLACES.deselect}
          onClick={() => actions.selectRegion(null)}
        >
          ×
        </button>
      </header>
      {children}
    </section>
  )
}

const SLIDERS = [
  { field: 'depth', label: LINE.depth, range: [-3, 3, 0.02] },
  { field: 'width', label: LINE.width, range: [0.2, 12, 0.1] },
  { field: 'softness', label: LINE.softness, range: [0, 1, 0.01] },
] as const

/** Depth, width and softness of a line, and its cross-section. */
function LineCard({ model }: { model: PanelModel }) {
  const { lines, actions } = model
  const line = lines.chosen.value!
  return (
    <>
      {lines.added.value.length > 0 && (
        <WhenQuestion
          model={model}
          added={lines.added.value}
          onAnswer={() => {
            lines.added.value = []
          }}
        />
      )}
      <LineSection line={line} label={CARD.section} />
      {SLIDERS.map(({ field, label, range }) => (
        <NumberSlider
          key={field}
          label={label}
          range={range}
          value={line[field]}
          onMove={(value) => actions.attempt(() => lines.fields.setShape({ [field]: value }))}
          onRest={() => lines.settle()}
        />
      ))}
    </>
  )
}
