import { signal } from '@preact/signals'
import type { StudioArea } from '../document/document.ts'
import { splitSide } from '../document/sides.ts'
import { intoRegion, PAINT, SCULPT } from '../labels/brushes.ts'
import { regionLabel } from '../labels/names.ts'
import { INSPECTOR, PLACES } from '../labels/page.ts'
import { FILE } from '../labels/project.ts'
import { ChosenArea } from '../panels/areas/chosen-area.tsx'
import { RegionSize } from '../panels/areas/region-size.tsx'
import { AutomaticWrinkles } from '../panels/automatic.tsx'
import { Section } from '../panels/controls/section.tsx'
import { Drivers } from '../panels/drivers/drivers.tsx'
import { Layers } from '../panels/layers.tsx'
import { Lines } from '../panels/lines.tsx'
import type { PanelModel } from '../panels/model.ts'
import { Motion } from '../panels/motion/motion.tsx'
import { BrushSettings } from '../panels/painting/painting.tsx'
import { SculptSettings } from '../panels/painting/sculpt.tsx'
import { Shapes } from '../panels/shapes/shapes.tsx'
import { Tabs } from '../ui/tabs.tsx'
import { SelectionCard } from './cards.tsx'
import { CannotWrinkle } from './no-shapes.tsx'
import { type Selected, selectedIn, wholeOf } from './selected.ts'
import { isSmallPage } from './small-page.ts'
import { WhenQuestion } from './when-question.tsx'

type Tab = 'look' | 'when' | 'maps'

const TABS = (['look', 'when', 'maps'] as const).map((value) => ({ value, label: PLACES[value] }))

const tab = signal<Tab>('look')

/** Panel at the right with the settings of the selection: the whole face, a region, or a line. */
export function Inspector({ model }: { model: PanelModel }) {
  const { tools, session, revision } = model
  revision.value
  if (!model.viewer.value) return null
  if (tools.mode.value === 'motion') return <Motion model={model} />
  const selected = selectedIn(model)
  if (!session.document.value) return <FromFile model={model} />
  return (
    <>
      {tools.mode.value === 'paint' && <Brush model={model} />}
      {isSmallPage.value && <SelectionCard model={model} />}
      <Heading selected={selected} model={model} />
      <Tabs
        label={PLACES.inspector}
        tabs={TABS}
        value={tab.value}
        onChange={(value) => {
          tab.value = value
        }}
      >
        {tab.value === 'look' && <Look selected={selected} model={model} />}
        {tab.value === 'when' && <When selected={selected} model={model} />}
        {tab.value === 'maps' && (
          <>
            <Layers model={model} shown={selected.layer} />
            <RegionSize model={model} />
          </>
        )}
      </Tabs>
    </>
  )
}

/** Settings of the brush, and the question when its new regions show. */
function Brush({ model }: { model: PanelModel }) {
  const { tools, areas } = model
  const [added, region] = [areas.added.value, areas.chosen.value]
  const isSculpting = tools.tool.value === 'sculpt'
  const noRegion = isSculpting ? SCULPT.noRegion : PAINT.noRegion
  return (
    <>
      <p class="hint">{region ? intoRegion(regionLabel(region.name), wholeOf(model)) : noRegion}</p>
      {isSculpting ? <SculptSettings model={model} /> : <BrushSettings model={model} />}
      {added.length > 0 && (
        <section>
          <WhenQuestion model={model} added={added} onAnswer={() => areas.forgetAdded()} />
        </section>
      )}
    </>
  )
}

interface PartProps {
  selected: Selected
  model: PanelModel
}

/** Name of the selection, and a button that ends the selection. */
function Heading({ selected: { kind, label, fileName }, model }: PartProps) {
  return (
    <div class="selected">
      <h2>
        {label} {fileName && <small>{fileName}</small>}
      </h2>
      {(kind === 'region' || kind === 'line') && (
        <button type="button" class="quiet" onClick={() => model.actions.selectRegion(null)}>
          {wholeOf(model)}
        </button>
      )}
    </div>
  )
}

function Look({ selected: { kind }, model }: PartProps) {
  if (kind === 'region') return <ChosenArea model={model} />
  if (kind === 'line' || kind === 'new line' || model.tools.mode.value === 'lines')
    return <Lines model={model} />
  return model.session.document.value?.auto ? <AutomaticWrinkles model={model} /> : <NoWrinkles />
}

function When({ selected: { kind, area, group }, model }: PartProps) {
  if (kind === 'region') return <Drivers model={model} area={area!.name} />
  if (kind === 'line') return <Owners areas={areasOf(group, model)} model={model} />
  if ((model.viewer.value?.targets.length ?? 0) > 0) return <Shapes model={model} />
  return <p class="hint">{INSPECTOR.noBlendshapes}</p>
}

/** Regions that show a line. */
function Owners({ areas, model }: { areas: readonly StudioArea[]; model: PanelModel }) {
  return (
    <>
      <p class="hint">{INSPECTOR.lineShows}</p>
      <div class="add">
        {areas.map(({ name }) => (
          <button key={name} type="button" onClick={() => model.actions.selectRegion(name)}>
            {regionLabel(name)}
          </button>
        ))}
      </div>
    </>
  )
}

function areasOf(group: string | undefined, { session }: PanelModel): readonly StudioArea[] {
  const areas = session.document.value?.areas ?? []
  const own = areas.filter(({ name }) => name === group)
  return own.length > 0 ? own : areas.filter(({ name }) => splitSide(name)[0] === group)
}

function NoWrinkles() {
  return <p class="hint">{INSPECTOR.fromFileEditable}</p>
}

/** Shown while the wrinkles are those of the avatar's file, which users cannot edit. */
function FromFile({ model }: { model: PanelModel }) {
  const { viewer, isBeginning, actions } = model
  if (isBeginning.value) return <p class="hint">{INSPECTOR.making}</p>
  const { avatar, wrinkles } = viewer.value!
  const skin = avatar.skins[avatar.skin]
  if (!wrinkles && skin.problem !== null) return <CannotWrinkle skin={skin} />
  if (!wrinkles) return <p class="hint">{INSPECTOR.noWrinkles}</p>
  return (
    <Section title={wholeOf(model)}>
      <p class="hint">{INSPECTOR.fromFile}</p>
      <button type="button" class="main" onClick={actions.editWrinkles}>
        {FILE.edit}
      </button>
    </Section>
  )
}
