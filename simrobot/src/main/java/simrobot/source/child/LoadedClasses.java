package simrobot.source.child;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simrobot.behaviour.Behaviour;

/** Loads compiled classes; each version of a source gets a loader of its own. */
public final class LoadedClasses extends ClassLoader {
    /** The name of every class loader of students' classes. */
    public static final String NAME = "behaviours";

    private final Map<String, byte[]> classes;

    public LoadedClasses(Map<String, byte[]> classes) {
        super(NAME, Behaviour.class.getClassLoader());
        this.classes = classes;
    }

    /** True if a constant of a class contains this ASCII name, such as that of a method which it calls. */
    public static boolean mention(Map<String, byte[]> classes, String name) {
        return classes.values().stream()
                .anyMatch(octets -> new String(octets, StandardCharsets.ISO_8859_1).contains(name));
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        byte[] octets = classes.get(name);
        if (octets == null) {
            throw new ClassNotFoundException(name);
        }
        return defineClass(name, octets, 0, octets.length);
    }

    /** Returns the class that is the process: the one with the file's name, else the only one that implements the interface. */
    public Optional<Class<? extends Behaviour>> behaviour(String fileName) {
        List<Class<? extends Behaviour>> found = classes.keySet().stream()
                .<Class<?>>map(this::loaded)
                .filter(LoadedClasses::isBehaviour)
                .<Class<? extends Behaviour>>map(type -> type.asSubclass(Behaviour.class))
                .toList();
        return found.stream()
                .filter(type -> type.getSimpleName().equals(fileName))
                .findFirst()
                .or(() -> found.size() == 1 ? found.stream().findFirst() : Optional.empty());
    }

    private Class<?> loaded(String name) {
        try {
            return loadClass(name);
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException("a class that was compiled just now is not there: " + name, e);
        }
    }

    private static boolean isBehaviour(Class<?> type) {
        return Behaviour.class.isAssignableFrom(type)
                && !Modifier.isAbstract(type.getModifiers())
                && Arrays.stream(type.getDeclaredConstructors()).anyMatch(each -> each.getParameterCount() == 0);
    }

    /** Creates an object; what its constructor throws is thrown. */
    public static Behaviour create(Class<?> type) throws Exception {
        Constructor<? extends Behaviour> constructor =
                type.asSubclass(Behaviour.class).getDeclaredConstructor();
        constructor.setAccessible(true);
        try {
            return constructor.newInstance();
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw e.getCause() instanceof Exception thrown ? thrown : e;
        }
    }
}
