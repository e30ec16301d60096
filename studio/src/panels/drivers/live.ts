import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { useEffect, useMemo } from 'preact/hooks'

/** Milliseconds between two numbers that are read and not watched. */
const READING = 250

/**
 * Follows a signal at most every `interval` milliseconds, and never misses its last value.
 *
 * @returns the slower signal, and what ends it.
 */
export function slowed<T>(source: ReadonlySignal<T>, interval: number): [ReadonlySignal<T>, () => void] {
  const slow = signal(source.peek())
  let timer: ReturnType<typeof setTimeout> | undefined
  let isWaiting = false
  const show = () => {
    slow.value = source.peek()
    isWaiting = false
    timer = setTimeout(() => {
      timer = undefined
      if (isWaiting) show()
    }, interval)
  }
  const stop = effect(() => {
    if (source.value === slow.peek()) return
    if (timer === undefined) show()
    else isWaiting = true
  })
  return [
    slow,
    () => {
      stop()
      clearTimeout(timer)
    },
  ]
}

/** A signal at a pace at which numbers can be read. */
export function useSlowed<T>(source: ReadonlySignal<T>): ReadonlySignal<T> {
  const [slow, stop] = useMemo(() => slowed(source, READING), [source])
  useEffect(() => stop, [stop])
  return slow
}
