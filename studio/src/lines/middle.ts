/** Loaded when lines are edited first, because recognising the halves of a face needs the templates of all shapes (60 kB). */
export { middleOf } from 'furrow/internal'
