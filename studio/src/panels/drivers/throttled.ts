import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { useEffect, useMemo } from 'preact/hooks'

/** Time between two updates of displayed numbers, milliseconds. */
const READING_INTERVAL = 250

/**
 * Makes a signal that follows another one, but changes at most once per `interval` (milliseconds). It never misses the last value.
 *
 * @returns the new signal, and a function that stops its updates.
 */
export function throttled<T>(source: ReadonlySignal<T>, interval: number): [ReadonlySignal<T>, () => void] {
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

/** Throttles a signal to a rate that users can read. */
export function useThrottled<T>(source: ReadonlySignal<T>): ReadonlySignal<T> {
  const [slow, stop] = useMemo(() => throttled(source, READING_INTERVAL), [source])
  useEffect(() => stop, [stop])
  return slow
}
