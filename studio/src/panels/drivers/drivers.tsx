import { signal, useComputed, useSignal } from '@preact/signals'
import type { ExpressionDriver, WrinkleDriver } from 'furrow'
import { useMemo } from 'preact/hooks'
import { driverProblems } from '../../document/driver-problems.ts'
import { areaOf, UNSET } from '../../document/drivers.ts'
import { DRIVERS, problemsLabel } from '../../labels/drivers.ts'
import { PLACES } from '../../labels/page.ts'
import { REGION } from '../../labels/regions.ts'
import { DriverEditor } from '../../session/driver-editor.ts'
import type { PanelModel } from '../model.ts'
import { AddDriver } from './add-driver.tsx'
import { Conflicts } from './conflicts.tsx'
import type { DriverContext } from './context.ts'
import { DriverCard } from './driver-card.tsx'
import { ShownBy } from './shown-by.tsx'
import { Strongest } from './strongest.tsx'
import { useThrottled } from './throttled.ts'

/** Whether all drivers of a region are shown, not only the strongest. */
const isAdvancedOpen = signal(false)

/** Expressions that show an area, its strongest drivers, and below them all drivers and conflicts between blendshapes. */
export function Drivers({ model, area }: { model: PanelModel; area: string }) {
  const { session, areas, viewer, revision, frame, actions } = model
  revision.value
  const document = session.document.value
  const editor = useMemo(() => new DriverEditor(session, actions.attempt), [session, actions])
  const now = useComputed(() => {
    frame.value
    return viewer.value?.driven.drivers.contributions() ?? []
  })
  const slow = useThrottled(now)
  const added = useSignal<number | null>(null)
  const sum = useComputed(() => {
    slow.value
    return (
      viewer.value?.areas
        .find(({ name }) => name === area)
        ?.read()
        .toFixed(2) ?? ''
    )
  })
  if (!document) return null
  const dials = viewer.value?.targets ?? []
  const context: DriverContext = {
    model,
    editor,
    area,
    targets: dials.map(({ name }) => name),
    areas: document.areas.map(({ name }) => name),
    pose: () => {
      const weights = dials.map((dial) => [dial.name, Number(dial.read().toFixed(3))] as const)
      return new Map(weights.filter(([, weight]) => Math.abs(weight) > UNSET))
    },
    now,
    slow,
  }
  const problems = driverProblems(document.drivers, area, context.targets)
  const own = document.drivers.flatMap((driver, index) =>
    isRelevant(driver, area) ? [{ driver, index }] : [],
  )
  return (
    <>
      <ShownBy area={area} model={model} />
      <Strongest drivers={document.drivers} context={context} />
      <button type="button" title={REGION.recordHint} onClick={() => areas.recordPose(area, actions.pose())}>
        {REGION.record}
      </button>
      <details
        class="drivers"
        open={isAdvancedOpen.value}
        onToggle={({ currentTarget }) => {
          isAdvancedOpen.value = currentTarget.open
        }}
      >
        <summary>
          {PLACES.advanced}
          {problems.size > 0 && <span class="problem">{problemsLabel(problems.size)}</span>}
        </summary>
        <h3>
          {PLACES.drivers}
          <output class="part" title={DRIVERS.activation} aria-live="off">
            {sum}
          </output>
        </h3>
        {own.length === 0 && <p class="hint">{DRIVERS.none}</p>}
        {own.map(({ driver, index }) => (
          <DriverCard
            key={`${index} ${driver.type}`}
            driver={driver}
            index={index}
            context={context}
            problem={problems.get(index)}
            open={index === added.value}
          />
        ))}
        <AddDriver
          document={document}
          context={context}
          onAdd={(driver) => {
            added.value = document.drivers.length
            editor.add(driver)
          }}
        />
        <Conflicts context={context} />
      </details>
    </>
  )
}

/** Whether a driver activates an area, or is an expression that names the area. */
function isRelevant(driver: WrinkleDriver, area: string): boolean {
  if (driver.type !== 'expression') return areaOf(driver) === area
  return (driver as ExpressionDriver).activations.some((each) => each.area === area)
}
