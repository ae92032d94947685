/** The windows of a lesson and of a class. Read {@link simgsm.classroom.ui.LessonPanel} first. */
package simgsm.classroom.ui;
