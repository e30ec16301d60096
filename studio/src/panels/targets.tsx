import { useSignal } from '@preact/signals'
import { useMemo } from 'preact/hooks'
import { foundLabel, TARGETS } from '../labels/blendshapes.ts'
import { PLACES } from '../labels/page.ts'
import { type Dial, groupShapes, type ShapeGroup } from '../viewer/pose/dials.ts'
import { FilterInput } from './controls/filter-input.tsx'
import { Section } from './controls/section.tsx'
import { Slider } from './controls/slider.tsx'
import type { PanelModel } from './model.ts'

/** Sliders of all blendshapes, in collapsible groups with a name filter. */
export function Targets({ model }: { model: PanelModel }) {
  const { viewer, revision, hovered, actions } = model
  // Muscles add blendshapes. Render again after changes of muscles.
  revision.value
  const dials = viewer.value?.targets
  const groups = useMemo(() => groupShapes(dials ?? []), [dials])
  const filter = useSignal('')
  const query = filter.value.trim().toLowerCase()
  const matches = ({ name }: Dial) => name.toLowerCase().includes(query)
  const count = (dials ?? []).filter(matches).length
  const area = hovered.value?.kind === 'area' ? hovered.value.name : undefined
  const linked = area === undefined ? [] : (viewer.value?.driven.drivers.targetsOf(area) ?? [])
  const aside = (
    <>
      <span class="hint" role="status">
        {query !== '' && foundLabel(count)}
      </span>
      <button
        type="button"
        class="quiet"
        aria-label={TARGETS.resetAll}
        onClick={() => actions.reset(dials ?? [])}
      >
        {TARGETS.reset}
      </button>
    </>
  )
  if (!dials || dials.length === 0) return null
  return (
    <Section title={PLACES.targets} aside={aside}>
      <div class="filter">
        <FilterInput label={TARGETS.filter} id="filter" filter={filter} />
      </div>
      <div id="targets" class="groups">
        {groups.map((group) => (
          <Group
            key={group.name}
            group={group}
            isFiltered={query !== ''}
            matches={matches}
            linked={linked}
            model={model}
          />
        ))}
      </div>
    </Section>
  )
}

interface GroupProps {
  group: ShapeGroup<Dial>
  /** Whether a filter is active. A filter opens all groups temporarily. */
  isFiltered: boolean
  /** Returns whether to show a slider. Hidden sliders still follow the face. */
  matches(dial: Dial): boolean
  /** Blendshapes that drive the area under the pointer. */
  linked: readonly string[]
  model: PanelModel
}

function Group({ group: { name, shapes: dials }, isFiltered, matches, linked, model }: GroupProps) {
  const { frame, hovered, actions } = model
  const isOpen = useSignal(false)
  const onHover = (dial: Dial | null) => {
    hovered.value = dial && { kind: 'target', name: dial.name }
  }
  return (
    <details
      hidden={!dials.some(matches)}
      class={dials.some((dial) => linked.includes(dial.name)) ? 'linked' : ''}
      open={isFiltered || isOpen.value}
      onToggle={({ currentTarget }) => {
        if (!isFiltered) isOpen.value = currentTarget.open
      }}
    >
      <summary>
        {name}
        <span>{dials.filter(matches).length}</span>
      </summary>
      {dials.map((dial) => (
        <Slider
          key={dial.name}
          dial={dial}
          frame={frame}
          linked={linked.includes(dial.name)}
          isHidden={!matches(dial)}
          onInput={actions.input}
          onHover={onHover}
        />
      ))}
    </details>
  )
}
