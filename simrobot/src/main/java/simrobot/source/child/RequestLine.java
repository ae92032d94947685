package simrobot.source.child;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simrobot.behaviour.BehaviourRequest;

/** A request of a process as a line: its word is the first one in the record's name, its values are the components. */
public final class RequestLine {
    private static final Map<String, Class<?>> TYPES = Arrays.stream(BehaviourRequest.class.getPermittedSubclasses())
            .collect(Collectors.toMap(RequestLine::word, type -> type));

    private RequestLine() {}

    static String of(String robot, BehaviourRequest request) {
        Stream<Object> values = Arrays.stream(request.getClass().getRecordComponents())
                .flatMap(component -> Stream.of(component.getName(), value(component, request)));
        return PipeLine.of(
                word(request.getClass()),
                Stream.concat(Stream.of("robot", robot), values).toArray());
    }

    private static Object value(RecordComponent component, BehaviourRequest request) {
        try {
            return component.getAccessor().invoke(request);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("no public record: " + request, e);
        }
    }

    private static String word(Class<?> type) {
        return type.getSimpleName().replaceFirst("(?<=[a-z])[A-Z].*", "").toLowerCase(Locale.ROOT);
    }

    /** Returns the request; empty if the line is none, or a value is refused. */
    public static Optional<BehaviourRequest> parse(PipeLine line) {
        return Optional.ofNullable(TYPES.get(line.word())).flatMap(type -> create(type, line));
    }

    private static Optional<BehaviourRequest> create(Class<?> type, PipeLine line) {
        RecordComponent[] components = type.getRecordComponents();
        try {
            Object[] values = Arrays.stream(components)
                    .map(component -> component.getType() == double.class
                            ? (Object) line.number(component.getName())
                            : line.text(component.getName()))
                    .toArray();
            Class<?>[] types =
                    Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
            return Optional.of((BehaviourRequest) type.getConstructor(types).newInstance(values));
        } catch (ReflectiveOperationException | IllegalArgumentException refused) {
            return Optional.empty();
        }
    }
}
