package simrobot.ros;

import java.math.BigDecimal;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The velocity in a geometry_msgs/Twist or TwistStamped; absent fields are 0.
 *
 * @param metersPerSecond ahead
 * @param radiansPerSecond anticlockwise
 */
record Twist(double metersPerSecond, double radiansPerSecond) {
    /** @throws IllegalArgumentException naming the first field that does not exist or has no finite number */
    static Twist of(Object message) {
        Map<?, ?> fields = object("msg", message, Set.of("linear", "angular", "header", "twist"));
        if (fields.containsKey("header") || fields.containsKey("twist")) {
            object("msg", fields, Set.of("header", "twist"));
            fields = object("twist", fields.get("twist"), Set.of("linear", "angular"));
        }
        double[] linear = vector(fields, "linear");
        double[] angular = vector(fields, "angular");
        return new Twist(linear[0], angular[2]);
    }

    private static double[] vector(Map<?, ?> fields, String name) {
        Map<?, ?> vector = fields.containsKey(name) ? object(name, fields.get(name), Set.of("x", "y", "z")) : Map.of();
        return List.of("x", "y", "z").stream()
                .mapToDouble(axis -> vector.containsKey(axis) ? number(name + "." + axis, vector.get(axis)) : 0)
                .toArray();
    }

    private static Map<?, ?> object(String name, Object value, Set<String> expected) {
        if (!(value instanceof Map<?, ?> object)) {
            throw new IllegalArgumentException(name + ": expected an object");
        }
        for (Object field : object.keySet()) {
            if (!expected.contains(field)) {
                throw new IllegalArgumentException(name + " does not have a field " + field);
            }
        }
        return object;
    }

    private static double number(String name, Object value) {
        if (value instanceof BigDecimal number && Double.isFinite(number.doubleValue())) {
            return number.doubleValue();
        }
        throw new IllegalArgumentException(name + ": expected a finite number");
    }
}
