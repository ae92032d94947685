/**
 * Lessons and the glossary in windows. Read {@link simgsm.ui.lesson.LessonPanel} first. Arrows: ui.lesson -&gt; lesson, ui.
 */
package simgsm.ui.lesson;
