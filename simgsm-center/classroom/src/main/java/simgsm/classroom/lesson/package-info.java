/**
 * Plays lessons: starts the programs of one, feeds their events to its run, performs solutions and prints the score. Read
 * {@link simgsm.classroom.lesson.LessonSession} first. Arrows: lesson -&gt; demo -&gt; app.
 */
package simgsm.classroom.lesson;
