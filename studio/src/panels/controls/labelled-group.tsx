import type { ComponentChildren } from 'preact'
import { useId } from 'preact/hooks'

interface LabelledGroupProps {
  label: string
  /** By default the label's column and the controls' column. */
  class?: string
  children: ComponentChildren
}

/** Controls with one label beside them. A `legend` stands above a fieldset's grid in WebKit, even where it floats. */
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
