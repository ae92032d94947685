package simrobot.ros;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** The services: orders to robots, and the requests of rosapi that clients use. */
final class RosServices {
    private static final String ROSAPI = "/rosapi/";
    private static final String ORDER = "/order";

    private final RosSession session;
    private final RosServer server;

    RosServices(RosSession session, RosServer server) {
        this.session = session;
        this.server = server;
    }

    /** @throws IllegalArgumentException if the request names no service; all other faults are answered as responses */
    void call(RosRequest request) {
        String service = request.name("service");
        try {
            call(request, service);
        } catch (IllegalArgumentException refusal) {
            session.send(request.response(refusal.getMessage(), false));
        }
    }

    private void call(RosRequest request, String service) {
        RosGeneration generation = request.optional("type")
                .filter(type -> type.contains("/srv/"))
                .map(type -> RosGeneration.ROS_2)
                .orElse(RosGeneration.ROS_1);
        Map<String, RosTopic.Source> topics = server.topics();
        switch (service) {
            case ROSAPI + "topics" -> {
                arguments(request);
                List<String> types = topics.values().stream()
                        .map(source -> source.topic().type(generation))
                        .toList();
                respond(request, Map.of("topics", List.copyOf(topics.keySet()), "types", types));
            }
            case ROSAPI + "topic_type" -> {
                String topic = arguments(request, "topic").name("topic");
                String type = Optional.ofNullable(topics.get(topic))
                        .map(source -> source.topic().type(generation))
                        .orElse("");
                respond(request, Map.of("type", type));
            }
            case ROSAPI + "get_time" -> {
                arguments(request);
                server.atSimulatedTime(nanos -> respond(request, Map.of("time", generation.time(nanos))));
            }
            default -> order(request, service);
        }
    }

    private void order(RosRequest request, String service) {
        String robot = server.source().robots().stream()
                .filter(name -> service.equals("/" + name + ORDER))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("Service " + service + " does not exist"));
        String keys = arguments(request, "keys").string("keys");
        server.order(
                robot,
                session.requirePower(),
                keys,
                (tone, text) -> respond(request, RosMessages.fields("tone text", tone, text)));
    }

    private void respond(RosRequest request, Map<String, Object> values) {
        session.send(request.response(values, true));
    }

    /** The arguments by name, from an object or an array in the order of the fields. */
    private static RosRequest arguments(RosRequest request, String... fields) {
        Map<String, Object> named = new LinkedHashMap<>();
        Object given = Objects.requireNonNullElse(request.fields().get("args"), Map.of());
        if (given instanceof List<?> values && values.size() <= fields.length) {
            for (int i = 0; i < values.size(); i++) {
                named.put(fields[i], values.get(i));
            }
        } else if (given instanceof Map<?, ?> values) {
            values.forEach((name, value) -> named.put(name.toString(), value));
        } else {
            throw new IllegalArgumentException("args: expected an object or at most " + fields.length + " values");
        }
        for (String name : named.keySet()) {
            if (!List.of(fields).contains(name)) {
                throw new IllegalArgumentException("args does not have a field " + name);
            }
        }
        return new RosRequest(named);
    }
}
