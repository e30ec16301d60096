// Opens only three examples, to save time in `npm test`. examples-all.test.ts opens the others.

import { expect, test } from 'vitest'
import { EXAMPLES } from './examples.ts'
import { useExamples } from './open-example.ts'

const { testWrinkles } = useExamples()
const quick = EXAMPLES.filter((example) => example.quick)

test('the table of examples selects three for this file', () => expect(quick).toHaveLength(3))

for (const example of quick) testWrinkles(example)
