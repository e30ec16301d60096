import { useComputed } from '@preact/signals'
import type { WrinkleDriver } from 'furrow'
import type { DriverProblem } from '../../document/driver-problems.ts'
import { DRIVERS } from '../../labels/drivers.ts'
import type { FormProps } from './context.ts'
import { driverTypeOf } from './types/types.ts'

interface DriverCardProps extends FormProps<WrinkleDriver> {
  problem: DriverProblem | undefined
  open: boolean
}

/** Card for one driver: its type, its current contribution, and a collapsible form. */
export function DriverCard({ driver, index, context, problem, open }: DriverCardProps) {
  const { slow, editor } = context
  const given = useComputed(() => slow.value[index]?.activation.toFixed(2) ?? '')
  const type = driverTypeOf(driver.type)
  return (
    <details class="driver" open={open}>
      <summary>
        <b>{type?.label ?? driver.type}</b>
        <span class="reads">{type?.reads?.(driver)}</span>
        <output class="part" title={DRIVERS.contribution} aria-live="off">
          {given}
        </output>
      </summary>
      {problem && (
        <p class="problem">
          {problem.text} {problem.remedy}
          {problem.removes !== undefined && (
            <button type="button" class="quiet fix" onClick={() => editor.remove(problem.removes!)}>
              {problem.removes === index ? DRIVERS.removeThis : DRIVERS.removeConflict}
            </button>
          )}
        </p>
      )}
      <div class="settings">
        {type && <type.Form {...{ driver, index, context }} />}
        <button type="button" class="quiet remove-driver" onClick={() => editor.remove(index)}>
          {DRIVERS.remove}
        </button>
      </div>
    </details>
  )
}
