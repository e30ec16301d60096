import { normalizeProps, useMachine } from '@zag-js/preact'
import * as tabs from '@zag-js/tabs'
import type { ComponentChildren } from 'preact'
import { useId } from 'preact/hooks'

interface TabsProps<T extends string> {
  label: string
  tabs: readonly { value: T; label: string }[]
  value: T
  onChange(value: T): void
  /** Content of the chosen tab. */
  children: ComponentChildren
}

export function Tabs<T extends string>({ label, tabs: list, value, onChange, children }: TabsProps<T>) {
  const service = useMachine(tabs.machine, {
    id: useId(),
    value,
    onValueChange: (next) => onChange(next.value as T),
  })
  const api = tabs.connect(service, normalizeProps)
  return (
    <div {...api.getRootProps()} class="tabs">
      <div {...{ ...api.getListProps(), 'aria-label': label }} class="tab-list">
        {list.map((tab) => (
          <button key={tab.value} {...api.getTriggerProps({ value: tab.value })}>
            {tab.label}
          </button>
        ))}
      </div>
      {list.map((tab) => (
        <div key={tab.value} {...api.getContentProps({ value: tab.value })} class="tab">
          {tab.value === value && children}
        </div>
      ))}
    </div>
  )
}
