/**
 * Lessons that check themselves: the files of a lesson, its conditions on events, and a run that marks its steps. No clock,
 * process or socket. Read {@link simgsm.lesson.LessonRun} first; docs/LESSONS.md describes the files.
 * Arrows: lesson -&gt; console.
 */
package simgsm.lesson;
