/**
 * The list of lessons and their teachers' sheets in the help of each window. Read {@link simgsm.ui.lesson.LessonList}
 * first.
 */
package simgsm.ui.lesson;
