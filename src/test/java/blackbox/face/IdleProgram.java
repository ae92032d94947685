package blackbox.face;

import java.lang.invoke.MethodHandles;
import java.lang.reflect.Proxy;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Stands behind a window that is only looked at: gives the answers named, and else none, an empty list, 0 or false. */
public final class IdleProgram {
    private IdleProgram() {}

    /**
     * Returns an object of {@code type} that does nothing.
     *
     * @param answers what methods return, by their names
     */
    public static <T> T behind(Class<T> type, Map<String, Object> answers) {
        return type.cast(Proxy.newProxyInstance(
                type.getClassLoader(),
                new Class<?>[] {type},
                (proxy, method, arguments) -> answers.containsKey(method.getName())
                        ? answers.get(method.getName())
                        : nothing(method.getReturnType())));
    }

    private static Object nothing(Class<?> type) throws Throwable {
        if (type == Optional.class) {
            return Optional.empty();
        }
        return type == List.class ? List.of() : MethodHandles.zero(type).invoke();
    }
}
