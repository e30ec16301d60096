import { options, type VNode } from 'preact'
// Loads Preact's compatibility with React before this file extends it.
import 'preact/compat'

const next = options.vnode

/**
 * Keeps `onChange` of inputs the browser's event, which fires once when a change ends. Zag.js loads `preact/compat`, which turns `onChange` into
 * `onInput` as React does. It does not turn `onChangeCapture`.
 */
options.vnode = (vnode: VNode<{ onChange?: unknown; onChangeCapture?: unknown }>) => {
  const { type, props } = vnode
  if ((type === 'input' || type === 'textarea') && props.onChange !== undefined) {
    props.onChangeCapture = props.onChange
    delete props.onChange
  }
  next?.(vnode)
}
