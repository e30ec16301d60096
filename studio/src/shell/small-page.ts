import { signal } from '@preact/signals'

/** Condition of `small-pages.css`. */
const query = matchMedia('(max-width: 960px), (max-height: 430px)')

/** Whether the page is so small that a sheet shows one panel at a time. */
export const isSmallPage = signal(query.matches)

query.addEventListener('change', ({ matches }) => {
  isSmallPage.value = matches
})
