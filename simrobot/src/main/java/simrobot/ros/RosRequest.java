package simrobot.ros;

import java.math.BigDecimal;
import java.util.Map;
import java.util.Optional;
import simgsm.web.JsonText;

/** A client's message, and its answers. Fields of a wrong type are refused by {@link IllegalArgumentException}. */
record RosRequest(Map<String, Object> fields) {
    private static final String ID = "id";

    /** @throws IllegalArgumentException if it is absent */
    String string(String name) {
        return optional(name).orElseThrow(() -> new IllegalArgumentException("expected " + name));
    }

    Optional<String> optional(String name) {
        Object value = fields.get(name);
        if (value != null && !(value instanceof String)) {
            throw new IllegalArgumentException(name + ": expected a string");
        }
        return Optional.ofNullable((String) value);
    }

    /** A number of milliseconds, 0 if absent. */
    long millis(String name) {
        Object value = fields.getOrDefault(name, BigDecimal.ZERO);
        if (value instanceof BigDecimal number && number.signum() >= 0 && number.doubleValue() <= Integer.MAX_VALUE) {
            return number.longValue();
        }
        throw new IllegalArgumentException(name + ": expected a number of milliseconds");
    }

    /** The name of a topic or service, with a leading slash. */
    String name(String field) {
        String name = string(field);
        return name.startsWith("/") ? name : "/" + name;
    }

    /** The client's id; null if it gave none. */
    Object id() {
        return fields.get(ID);
    }

    /** The status message for this request. */
    String status(String level, String text) {
        return answer(RosMessages.fields("op level msg", "status", level, text));
    }

    /**
     * The response to a service call.
     *
     * @param values a text gives the reason of a missing result
     */
    String response(Object values, boolean hasResult) {
        return answer(RosMessages.fields(
                "op service values result", "service_response", fields.get("service"), values, hasResult));
    }

    private String answer(Map<String, Object> answer) {
        if (fields.containsKey(ID)) {
            answer.put(ID, id());
        }
        return new JsonText().any(answer).toString();
    }
}
