import type { ComponentChildren } from 'preact'
import { useId } from 'preact/hooks'

interface LabelledGroupProps {
  label: string
  /** CSS class. Default: a row with a label column and a control column. */
  class?: string
  children: ComponentChildren
}

/** Labelled group of controls. The label is not a `legend`, which WebKit would place above the grid. */
export function LabelledGroup({ label, class: name = 'setting', children }: LabelledGroupProps) {
  const id = useId()
  return (
    <fieldset class={name} aria-labelledby={id}>
      <span id={id} class="label">
        {label}
      </span>
      {children}
    </fieldset>
  )
}
