/** The list of lessons and their teachers' sheets, which the help of each window shows. Read {@link simgsm.ui.lesson.LessonList} first. */
package simgsm.ui.lesson;
