import type { Signal } from '@preact/signals'
import * as dialog from '@zag-js/dialog'
import { normalizeProps, useMachine } from '@zag-js/preact'
import type { ComponentChildren } from 'preact'
import { useId } from 'preact/hooks'
import { FILE } from '../labels/project.ts'

interface DialogProps {
  title: string
  isOpen: Signal<boolean>
  children: ComponentChildren
}

export function Dialog({ title, isOpen, children }: DialogProps) {
  const service = useMachine(dialog.machine, {
    id: useId(),
    open: isOpen.value,
    onOpenChange: ({ open }) => {
      isOpen.value = open
    },
  })
  const api = dialog.connect(service, normalizeProps)
  if (!api.open) return null
  return (
    <>
      <div {...api.getBackdropProps()} class="backdrop" />
      <div {...api.getPositionerProps()} class="dialog-place">
        <div {...api.getContentProps()} class="dialog">
          <div class="dialog-title">
            <h2 {...api.getTitleProps()}>{title}</h2>
            <button {...api.getCloseTriggerProps()}>{FILE.close}</button>
          </div>
          {children}
        </div>
      </div>
    </>
  )
}
