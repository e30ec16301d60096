import { signal } from '@preact/signals'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { throttled } from '../../../studio/src/panels/drivers/throttled.ts'

beforeEach(() => {
  vi.useFakeTimers()
})
afterEach(() => {
  vi.useRealTimers()
})

it('a displayed number changes only a few times a second, and ends with the last value', () => {
  const source = signal(0)
  const [slow, stop] = throttled(source, 250)
  const seen: number[] = []
  slow.subscribe((value) => seen.push(value))
  for (let frame = 1; frame <= 60; frame++) {
    source.value = frame
    vi.advanceTimersByTime(1000 / 60)
  }
  expect(seen.length).toBeLessThanOrEqual(6)
  vi.advanceTimersByTime(1000)
  expect(slow.value).toBe(60)
  stop()
  source.value = 61
  vi.advanceTimersByTime(1000)
  expect(slow.value).toBe(60)
})

it('the first change is shown immediately', () => {
  const source = signal(0)
  const [slow, stop] = throttled(source, 250)
  source.value = 1
  expect(slow.value).toBe(1)
  stop()
})
