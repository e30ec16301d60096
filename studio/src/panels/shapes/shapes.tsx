import { useSignal } from '@preact/signals'
import { useEffect, useId } from 'preact/hooks'
import { hasOutdatedWrinkles } from '../../document/shapes.ts'
import { SHAPES, shapeCountsLabel } from '../../labels/blendshapes.ts'
import { PLACES } from '../../labels/page.ts'
import type { ShapeRow as Row } from '../../session/shape-editor.ts'
import { Check } from '../controls/check.tsx'
import { FilterInput } from '../controls/filter-input.tsx'
import { Section } from '../controls/section.tsx'
import type { PanelModel } from '../model.ts'
import { isUnknown, shapeLabel } from './recognised.ts'
import { ShapeRow } from './shape-row.tsx'

/** Time from the last correction until blendshapes are recognised again, milliseconds. */
const PAUSE = 500

/** Section that lists the shapes that were recognised for the skin's blendshapes, and lets the user correct them. */
export function Shapes({ model }: { model: PanelModel }) {
  const { shapes, actions } = model
  const isOpen = useSignal(false)
  const rows = shapes.rows.value
  const skin = shapes.skin.value
  // While the section is open, recognise blendshapes again for each new avatar and after corrections. A correction can affect other blendshapes.
  useEffect(() => {
    if (!isOpen.value || shapes.isCurrent.peek()) return undefined
    const timer = setTimeout(() => actions.attempt(() => shapes.recognise()), rows ? PAUSE : 0)
    return () => clearTimeout(timer)
  }, [isOpen.value, skin])
  return (
    <Section
      title={PLACES.shapes}
      open={false}
      onToggle={(isOpenNow) => {
        isOpen.value = isOpenNow
      }}
    >
      <p class="hint">{SHAPES.hint}</p>
      <Outdated model={model} />
      {isOpen.value && !rows && <Progress model={model} />}
      {isOpen.value && rows && <ShapeList rows={rows} model={model} />}
    </Section>
  )
}

function Progress({ model: { shapes, actions } }: { model: PanelModel }) {
  const id = useId()
  // Recognition has not started yet, or has failed.
  if (!shapes.isRunning.value)
    return (
      <button type="button" onClick={() => actions.attempt(() => shapes.recognise())}>
        {SHAPES.recognise}
      </button>
    )
  return (
    <div class="run">
      <label for={id}>{SHAPES.recognising}</label>
      <progress id={id} />
    </div>
  )
}

/** Explains that corrections do not change existing wrinkles. */
function Outdated({ model }: { model: PanelModel }) {
  const { session, auto, autoRun, actions } = model
  const document = session.document.value
  const isOutdated = document !== null && !autoRun.value && hasOutdatedWrinkles(document)
  return (
    <div role="status">
      {isOutdated && (
        <div class="outdated">
          <p>{SHAPES.outdated}</p>
          <button type="button" onClick={() => actions.makeAuto(auto.peek())}>
            {SHAPES.makeAgain}
          </button>
        </div>
      )}
      {document?.shapes && !document.auto && <p class="hint">{SHAPES.kept}</p>}
    </div>
  )
}

function ShapeList({ rows, model }: { rows: readonly Row[]; model: PanelModel }) {
  const { shapes, hovered } = model
  const filter = useSignal('')
  const isUnknownOnly = useSignal(false)
  const query = filter.value.trim().toLowerCase()
  // Never hide the row that the user is correcting.
  const held = hovered.peek()?.kind === 'shape' ? hovered.peek()!.name : undefined
  const matches = (row: Row) =>
    row.name === held ||
    ((!isUnknownOnly.value || isUnknown(row)) &&
      `${row.name} ${shapeLabel(row)}`.toLowerCase().includes(query))
  const count = rows.filter(matches).length
  const unknown = rows.filter(isUnknown).length
  return (
    <>
      <div class="shape-filter">
        <FilterInput label={SHAPES.filter} filter={filter} />
        <Check value={isUnknownOnly}>{SHAPES.unknownOnly}</Check>
      </div>
      <p class="hint" role="status">
        {shapes.isRunning.value ? SHAPES.recognisingOthers : shapeCountsLabel(count, rows.length, unknown)}
      </p>
      <ul class="shapes" aria-label={PLACES.shapes}>
        {rows.map((row, i) => (
          <ShapeRow key={i} row={row} isHidden={!matches(row)} model={model} />
        ))}
      </ul>
    </>
  )
}
