import { type Signal, useSignal } from '@preact/signals'
import * as popover from '@zag-js/popover'
import { normalizeProps, useMachine } from '@zag-js/preact'
import type { ComponentChildren } from 'preact'
import { useId } from 'preact/hooks'

interface PopoverProps {
  /** Accessible name of the button and of the content. */
  label: string
  /** Content of the button. */
  button: ComponentChildren
  class?: string
  placement?: 'bottom-start' | 'bottom-end' | 'top-end'
  /** Whether the card is open, for callers that close it. */
  isOpen?: Signal<boolean>
  children: ComponentChildren
}

/** Button that opens a card beside it. */
export function Popover(props: PopoverProps) {
  const { label, button, placement = 'bottom-start', children } = props
  const local = useSignal(false)
  const isOpen = props.isOpen ?? local
  const service = useMachine(popover.machine, {
    id: useId(),
    positioning: { placement, strategy: 'fixed', gutter: 6, overflowPadding: 8 },
    open: isOpen.value,
    onOpenChange: ({ open }) => {
      isOpen.value = open
    },
  })
  const api = popover.connect(service, normalizeProps)
  return (
    <>
      <button {...api.getTriggerProps()} class={props.class} aria-label={label} title={label}>
        {button}
      </button>
      <div {...api.getPositionerProps()} class="popover-place">
        <div {...{ ...api.getContentProps(), 'aria-label': label }} class="popover">
          {children}
        </div>
      </div>
    </>
  )
}
