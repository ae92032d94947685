package simrobot.source;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simrobot.behaviour.Behaviour;

/** Loads compiled classes; each version of a source gets a loader of its own. */
final class LoadedClasses extends ClassLoader {
    private final Map<String, byte[]> classes;

    LoadedClasses(Map<String, byte[]> classes) {
        super("behaviours", Behaviour.class.getClassLoader());
        this.classes = classes;
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        byte[] octets = classes.get(name);
        if (octets == null) {
            throw new ClassNotFoundException(name);
        }
        return defineClass(name, octets, 0, octets.length);
    }

    /**
     * Returns the process's class: the one with the file's name, else the only one that implements the interface.
     *
     * @throws SourceException if there is none
     */
    Class<? extends Behaviour> behaviour(String fileName) throws SourceException {
        List<Class<? extends Behaviour>> found;
        try {
            found = classes.keySet().stream()
                    .<Class<?>>map(this::loaded)
                    .filter(LoadedClasses::isBehaviour)
                    .<Class<? extends Behaviour>>map(type -> type.asSubclass(Behaviour.class))
                    .toList();
        } catch (LinkageError e) {
            throw new SourceException(0, FaultPlace.text(e));
        }
        return found.stream()
                .filter(type -> type.getSimpleName().equals(fileName))
                .findFirst()
                .or(() -> found.size() == 1 ? found.stream().findFirst() : Optional.empty())
                .orElseThrow(() -> new SourceException(
                        0,
                        "no class that is a process, expected: public class " + fileName
                                + " implements simrobot.behaviour.Behaviour, with a constructor without parameters"));
    }

    private Class<?> loaded(String name) {
        try {
            return loadClass(name);
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException("a class that was compiled just now is not there: " + name, e);
        }
    }

    private static boolean isBehaviour(Class<?> type) {
        boolean concrete = !type.isInterface() && !Modifier.isAbstract(type.getModifiers());
        if (!concrete || !Behaviour.class.isAssignableFrom(type)) {
            return false;
        }
        try {
            type.getDeclaredConstructor();
            return true;
        } catch (NoSuchMethodException e) {
            return false;
        }
    }

    /** Creates an object; exceptions of its constructor are passed on. */
    static Behaviour create(Class<? extends Behaviour> type) throws Exception {
        Constructor<? extends Behaviour> constructor = type.getDeclaredConstructor();
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
