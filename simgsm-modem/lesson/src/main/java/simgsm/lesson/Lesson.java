package simgsm.lesson;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A lesson without its texts.
 *
 * @param name of its folder
 * @param minutes of a class
 * @param center options of the centre, without their hyphens
 * @param closed numbers of the SIMs accepted by the network; empty for an open network
 * @param isCaptured true if the centre writes {@code lesson.pcap}
 */
public record Lesson(
        String name,
        int minutes,
        Map<String, String> center,
        List<LessonProgram> programs,
        List<String> closed,
        boolean isCaptured,
        List<LessonAction> actions,
        List<LessonStep> steps,
        List<LessonVariable> variables) {
    public Lesson {
        center = Map.copyOf(center);
        programs = List.copyOf(programs);
        closed = List.copyOf(closed);
        actions = List.copyOf(actions);
        steps = List.copyOf(steps);
        variables = List.copyOf(variables);
    }

    public Optional<LessonAction> action(String wanted) {
        return actions.stream().filter(action -> action.name().equals(wanted)).findFirst();
    }

    public Optional<LessonProgram> program(String wanted) {
        return programs.stream()
                .filter(program -> program.name().equals(wanted))
                .findFirst();
    }
}
