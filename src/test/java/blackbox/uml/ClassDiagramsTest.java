package blackbox.uml;

import blackbox.MainCode;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.JavaModifier;
import java.lang.module.ModuleDescriptor;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * The public face of each package, printed from the compiled classes: public types that classes outside the package use,
 * the methods of its interfaces, inheritance, which type holds which (solid) and takes which as a parameter (dashed). A face
 * of fewer than three types has no diagram.
 */
class ClassDiagramsTest {
    @Test
    void thePublicFaceOfEachPackage() throws Exception {
        Map<String, List<JavaClass>> faces = MainCode.CLASSES.stream()
                .filter(ClassDiagramsTest::isOfTheFace)
                .sorted(Comparator.comparing(JavaClass::getName))
                .collect(Collectors.groupingBy(JavaClass::getPackageName, TreeMap::new, Collectors.toList()));
        Set<String> files = new TreeSet<>();
        for (ModuleDescriptor module : MainCode.descriptors()) {
            for (String name : new TreeSet<>(module.packages())) {
                if (faces.getOrDefault(name, List.of()).size() >= 3) {
                    String file = "classes-" + Diagram.fileName(name) + ".puml";
                    files.add(file);
                    Diagram.hold("design/" + file, diagram(module, name, faces.get(name)));
                }
            }
        }
        Diagram.holdOnly("design", "classes-", files);
    }

    /** Public, on the top level, and used by another package. */
    private static boolean isOfTheFace(JavaClass type) {
        return type.getModifiers().contains(JavaModifier.PUBLIC)
                && type.isTopLevelClass()
                && type.getDirectDependenciesToSelf().stream()
                        .anyMatch(use -> !use.getOriginClass().getPackageName().equals(type.getPackageName()));
    }

    private static String diagram(ModuleDescriptor module, String name, List<JavaClass> face) {
        StringBuilder uml = new StringBuilder(Diagram.head("Public face of " + name + ", module " + module.name()));
        uml.append("hide empty members\nhide circle\n");
        face.forEach(type -> declare(uml, type));
        Set<String> arrows = new TreeSet<>();
        face.forEach(type -> arrows(type, face, arrows));
        arrows.forEach(arrow -> uml.append(arrow).append('\n'));
        return uml.append("@enduml\n").toString();
    }

    private static void declare(StringBuilder uml, JavaClass type) {
        uml.append(type.isInterface() ? "interface " : type.isEnum() ? "enum " : "class ")
                .append(type.getSimpleName())
                .append(type.isRecord() ? " <<record>>" : "");
        Set<String> methods = type.isInterface()
                ? type.getMethods().stream()
                        .filter(method -> !method.getModifiers().contains(JavaModifier.STATIC))
                        .filter(method -> !method.getModifiers().contains(JavaModifier.SYNTHETIC))
                        .filter(method -> !method.getModifiers().contains(JavaModifier.PRIVATE))
                        .map(ClassDiagramsTest::signature)
                        .collect(Collectors.toCollection(TreeSet::new))
                : Set.of();
        if (methods.isEmpty()) {
            uml.append('\n');
            return;
        }
        uml.append(" {\n");
        methods.forEach(method -> uml.append("  ").append(method).append('\n'));
        uml.append("}\n");
    }

    private static String signature(JavaMethod method) {
        return method.getName()
                + method.getRawParameterTypes().stream()
                        .map(JavaClass::getSimpleName)
                        .collect(Collectors.joining(", ", "(", ")"));
    }

    private static void arrows(JavaClass type, List<JavaClass> face, Set<String> arrows) {
        type.getRawSuperclass()
                .filter(face::contains)
                .ifPresent(parent -> arrows.add(parent.getSimpleName() + " <|-- " + type.getSimpleName()));
        type.getRawInterfaces().stream()
                .filter(face::contains)
                .forEach(port -> arrows.add(port.getSimpleName() + " <|.. " + type.getSimpleName()));
        Set<JavaClass> held = type.getFields().stream()
                .filter(field -> !field.getModifiers().contains(JavaModifier.STATIC))
                .flatMap(field -> field.getType().getAllInvolvedRawTypes().stream())
                .collect(Collectors.toSet());
        Set<JavaClass> taken = type.getCodeUnits().stream()
                .filter(unit -> unit.getModifiers().contains(JavaModifier.PUBLIC))
                .flatMap(unit -> unit.getParameterTypes().stream())
                .flatMap(parameter -> parameter.getAllInvolvedRawTypes().stream())
                .filter(parameter -> !held.contains(parameter))
                .collect(Collectors.toSet());
        arrows(type, "-->", held, face, arrows);
        arrows(type, "..>", taken, face, arrows);
    }

    private static void arrows(
            JavaClass type, String arrow, Set<JavaClass> used, List<JavaClass> face, Set<String> arrows) {
        used.stream()
                .filter(other -> !other.equals(type) && face.contains(other) && !type.isAssignableTo(other.getName()))
                .forEach(other -> arrows.add(type.getSimpleName() + " " + arrow + " " + other.getSimpleName()));
    }
}
