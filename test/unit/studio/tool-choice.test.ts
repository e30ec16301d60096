import { expect, it } from 'vitest'
import { ToolChoice } from '../../../studio/src/tools/tool-choice.ts'

it('a tool chooses its mode, and a mode its first tool', () => {
  const tools = new ToolChoice()
  const now = () => [tools.mode.value, tools.tool.value]
  expect(now()).toEqual(['look', 'select'])
  tools.choose('draw')
  expect(now()).toEqual(['lines', 'draw'])
  tools.chooseMode('lines')
  expect(now()).toEqual(['lines', 'draw'])
  tools.chooseMode('paint')
  expect(now()).toEqual(['paint', 'paint'])
  tools.choose('select')
  expect(now()).toEqual(['look', 'select'])
  tools.chooseMode('motion')
  tools.choose('select')
  expect(now()).toEqual(['motion', 'select'])
})
