/**
 * Plays lessons: starts the programs of one, feeds their events to its run, performs solutions and prints the score. Read
 * {@link simgsm.classroom.lesson.LessonSession} first. Arrows: lesson -&gt; demo, session, ui.
 */
package simgsm.classroom.lesson;
