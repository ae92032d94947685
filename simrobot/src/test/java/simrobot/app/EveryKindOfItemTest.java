package simrobot.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.draw.SvgCanvas;
import simrobot.camera.Camera;
import simrobot.drawing.Layers;
import simrobot.drawing.Viewport;
import simrobot.drawing.WorldPainter;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.ForbiddenArea;
import simrobot.world.ForbiddenLine;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.ItemKind;
import simrobot.world.ItemKinds;
import simrobot.world.MapWriter;
import simrobot.world.Point;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;
import simrobot.world.WorldItem;
import simrobot.world.WorldReader;

/** A kind of item that is declared is known to the map, the print-out, the editor, the pictures and the camera. */
class EveryKindOfItemTest {
    private static final List<WorldItem> SAMPLES = List.of(
            new Segment(1, -0.5, 1, 0.5),
            new Point(1, 0.01),
            new Home("A", new Position(1.5, 0), 0.25),
            new Box("desk", new Area(1, -0.5, 2, 0.5, 0)),
            new Goal("Dock", "B", new Position(1.5, 0), 0.5),
            new ForbiddenLine(new Segment(1, -0.5, 2, 0.5)),
            new ForbiddenArea(new Area(1, -0.5, 2, 0.5, 0)),
            new Treadmill(new Area(1, -0.5, 2, 0.5, 0), 0.3, 1));

    /** They bind planners only, so no camera sees them. */
    private static final Set<ItemKind<?>> UNSEEN = Set.of(ForbiddenLine.KIND, ForbiddenArea.KIND);

    /** Walls around the samples, so that all worlds have the same bounds. */
    private static final List<Segment> FENCE = List.of(
            new Segment(-3, -3, 3, -3), new Segment(3, -3, 3, 3), new Segment(3, 3, -3, 3), new Segment(-3, 3, -3, -3));

    static Stream<WorldItem> samples() {
        return SAMPLES.stream();
    }

    private static World with(WorldItem item) {
        List<WorldItem> items = new ArrayList<>(FENCE);
        items.add(item);
        return World.of("with.map", items);
    }

    @Test
    void everyClassOfItemsIsListedAndHasASampleHere() throws Exception {
        Path classes = Path.of(
                World.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        try (Stream<Path> files = Files.list(classes.resolve("simrobot/world"))) {
            Set<Class<?>> items = files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(".class"))
                    .map(name -> ofWorld(name.substring(0, name.length() - ".class".length())))
                    .filter(type -> WorldItem.class.isAssignableFrom(type) && type.isRecord())
                    .collect(Collectors.toSet());
            assertEquals(items, ItemKinds.ALL.stream().map(ItemKind::type).collect(Collectors.toSet()));
        }
        assertEquals(ItemKinds.ALL, SAMPLES.stream().map(WorldItem::kind).toList());
    }

    private static Class<?> ofWorld(String name) {
        try {
            return Class.forName("simrobot.world." + name);
        } catch (ClassNotFoundException e) {
            throw new AssertionError(e);
        }
    }

    @ParameterizedTest
    @MethodSource("samples")
    void theMapThatIsWrittenIsReadAsTheSame(WorldItem item) throws Exception {
        World world = with(item);
        byte[] map = MapWriter.text(world).getBytes(StandardCharsets.UTF_8);
        assertEquals(world, WorldReader.read(Path.of("with.map"), map));
    }

    @ParameterizedTest
    @MethodSource("samples")
    void allItsFieldsArePrinted(WorldItem item) {
        assertEquals(1 + item.kind().fields().size(), item.kind().printed(item).size());
        assertFalse(item.kind().fields().isEmpty());
    }

    @ParameterizedTest
    @MethodSource("samples")
    void theFormOfOneThatIsEditedHasItsTextsAndChangesNothingByItself(WorldItem item) {
        ItemKind<?> kind = item.kind();
        if (kind.isEdited()) {
            for (String language : List.of("en", "es")) {
                ResourceBundle texts =
                        ResourceBundle.getBundle("simrobot.ui.messages", Locale.forLanguageTag(language));
                assertTrue(texts.containsKey("editor.tool." + kind.word()), language);
                assertTrue(texts.containsKey("editor.item." + kind.word()), language);
                kind.form(item).keySet().forEach(key -> assertTrue(texts.containsKey("editor.field." + key), key));
            }
            assertEquals(item, kind.changed(item, Map.of()));
            assertEquals(
                    kind,
                    kind.drawn(World.bare(), new Position(0, 0), new Position(1, 1))
                            .kind());
        }
    }

    @ParameterizedTest
    @MethodSource("samples")
    void itIsDrawnInTheWindowAndOnThePage(WorldItem item) {
        assertNotEquals(picture(World.of("with.map", FENCE)), picture(with(item)));
    }

    private static String picture(World world) {
        SvgCanvas canvas = new SvgCanvas(Object::toString);
        SimulationSnapshot scene = new Simulation(world, 1).snapshot();
        WorldPainter.paint(canvas, scene, Viewport.picture(world.ground(), 960, 200, 48), Layers.ALL, null);
        return canvas.elements();
    }

    @ParameterizedTest
    @MethodSource("samples")
    void theCameraSeesWhatLiesOrStandsThere(WorldItem item) {
        boolean isSeen = !photo(World.of("with.map", FENCE)).equals(photo(with(item)));
        assertEquals(!UNSEEN.contains(item.kind()), isSeen);
    }

    private static List<Integer> photo(World world) {
        Simulation simulation = new Simulation(world, 1);
        simulation.addRobot("eye", new Position(-1, 0), 0);
        SimulationSnapshot scene = simulation.snapshot();
        BufferedImage image = new Camera().picture(scene, scene.robots().get(0));
        return Arrays.stream(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
                .boxed()
                .toList();
    }
}
