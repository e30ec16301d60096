import { useComputed } from '@preact/signals'
import type { ExpressionDriver, InputDriver, MuscleDriver, WrinkleDriver } from 'furrow'
import type { DriverFault } from '../../document/driver-faults.ts'
import type { FormProps } from './context.ts'
import { DriverForm } from './forms.tsx'
import { labelOf } from './labels.ts'

interface DriverCardProps extends FormProps<WrinkleDriver> {
  fault: DriverFault | undefined
  open: boolean
}

/** One driver: what it is and gives now, and below that, unfolded, its form. */
export function DriverCard({ driver, index, context, fault, open }: DriverCardProps) {
  const { slow, editor } = context
  const given = useComputed(() => slow.value[index]?.activation.toFixed(2) ?? '')
  const label = labelOf(driver.type)
  return (
    <details class="driver" open={open}>
      <summary>
        <b>{label}</b>
        <span class="reads">{readText(driver)}</span>
        <output class="part" title="What it gives now" aria-live="off">
          {given}
        </output>
      </summary>
      {fault && (
        <p class="fault">
          {fault.text} {fault.remedy}
          {fault.removes !== undefined && (
            <button type="button" class="quiet mend" onClick={() => editor.remove(fault.removes!)}>
              {fault.removes === index ? 'Remove it' : 'Remove the conflict'}
            </button>
          )}
        </p>
      )}
      <div class="settings">
        <DriverForm {...{ driver, index, context }} />
        <button type="button" class="quiet remove-driver" onClick={() => editor.remove(index)}>
          Remove this driver
        </button>
      </div>
    </details>
  )
}

/** What a driver reads, in a few words. */
function readText(driver: WrinkleDriver): string {
  const { targets, areas, joints } = driver as Record<string, unknown>
  if (driver.type === 'morph') return namesOf(targets)
  if (driver.type === 'area') return namesOf(areas)
  if (driver.type === 'bone') return (joints as string[])[1]
  const { name } = driver as InputDriver | MuscleDriver | ExpressionDriver
  return name ?? ''
}

function namesOf(links: unknown): string {
  return (links as { name: string }[]).map(({ name }) => name).join(', ')
}
