package simrobot.app.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.ui.window.WindowMemory;
import simrobot.app.SimRobotOptions;

class RecentWorldsTest {
    @TempDir
    private Path folder;

    private Optional<WindowMemory> memory;

    @BeforeEach
    void memory() {
        memory = Optional.of(new WindowMemory(folder.resolve("settings")));
    }

    private Path world(String name) throws Exception {
        return Files.writeString(folder.resolve(name), "2D-Map\n");
    }

    @Test
    void theNewestIsFirstAndStandsThereOnce() throws Exception {
        RecentWorlds recent = new RecentWorlds(memory);
        Path a = world("a.map");
        Path b = world("b \u00e9.map");
        recent.add(a);
        recent.add(b);
        recent.add(folder.resolve("x").resolve("..").resolve("a.map"));
        assertEquals(List.of(a, b), recent.files());
        assertEquals(Optional.of(a), first());
        assertEquals(List.of(a, b), new RecentWorlds(memory).files());
    }

    @Test
    void eightAreKept() throws Exception {
        RecentWorlds recent = new RecentWorlds(memory);
        for (int i = 0; i < 12; i++) {
            recent.add(world("w" + i + ".map"));
        }
        assertEquals(8, new RecentWorlds(memory).files().size());
        assertEquals(Optional.of(folder.resolve("w11.map")), first());
    }

    @Test
    void aFileThatIsGoneIsLeftOut() throws Exception {
        RecentWorlds recent = new RecentWorlds(memory);
        recent.add(world("a.map"));
        recent.add(world("b.map"));
        Files.delete(folder.resolve("b.map"));
        assertEquals(List.of(folder.resolve("a.map")), recent.files());
        assertEquals(Optional.of(folder.resolve("a.map")), first());
    }

    @Test
    void aFileThatIsNoWorldAnyMoreIsNotBegunWith() throws Exception {
        RecentWorlds recent = new RecentWorlds(memory);
        recent.add(world("a.map"));
        recent.add(world("b.map"));
        Files.writeString(folder.resolve("b.map"), "2D-Map\nLINES\n1 2\n");
        assertEquals(Optional.of(folder.resolve("a.map")), first());
    }

    @Test
    void aFileThatIsNoWorldAnyMoreIsNotListedUntilItIsAWorldAgain() throws Exception {
        Path a = world("a.map");
        Path b = world("b.map");
        new RecentWorlds(memory).add(a);
        new RecentWorlds(memory).add(b);
        Files.writeString(b, "2D-Map\nLINES\n1 2\n");
        RecentWorlds recent = new RecentWorlds(memory);
        RecentWorlds.Start start = recent.start(SimRobotOptions.all().parse(List.of()));
        assertEquals(Optional.of(a), start.file());
        assertEquals("a.map", start.world().name());
        assertEquals(List.of(a), recent.files());
        recent.add(a);
        recent.add(world("b.map"));
        assertEquals(List.of(b, a), recent.files());
        recent.leaveOut(a);
        assertEquals(List.of(b), recent.files());
        assertEquals(List.of(b, a), new RecentWorlds(memory).files(), "the next run tries again");
    }

    @Test
    void onlyAWindowThatItsUserStartsBeginsWithTheNewest() throws Exception {
        new RecentWorlds(memory).add(world("a.map"));
        assertEquals(Optional.of(folder.resolve("a.map")), first());
        assertEquals(Optional.empty(), first("--headless"));
        assertEquals(Optional.empty(), first("--end-with-input"));
        assertEquals(Optional.empty(), first("--console"));
        assertEquals(Optional.empty(), first("--remember-as", "demo-robot"));
    }

    @Test
    void aNamedWorldIsBegunWithAndIsTheNewestFromThenOn() throws Exception {
        Path a = world("a.map");
        Path b = world("b.map");
        new RecentWorlds(memory).add(a);
        assertEquals(Optional.of(b), first("--world", b.toString(), "--console"));
        assertEquals(Optional.of(a), first());
        assertEquals(Optional.of(b), first("--world", b.toString()));
        assertEquals(Optional.of(b), first());
    }

    private Optional<Path> first(String... words) throws Exception {
        return new RecentWorlds(memory)
                .start(SimRobotOptions.all().parse(List.of(words)))
                .file();
    }

    @Test
    void aListThatSomethingElseHasWrittenIsLeftOut() throws Exception {
        memory.get()
                .keepList(
                        "robot-worlds",
                        List.of("a\u0000b", folder.toString(), world("a.map").toString()));
        assertEquals(Optional.of(folder.resolve("a.map")), first());
    }

    @Test
    void withoutAMemoryTheyLastForTheSession() throws Exception {
        RecentWorlds recent = new RecentWorlds(Optional.empty());
        recent.add(world("a.map"));
        assertEquals(List.of(folder.resolve("a.map")), recent.files());
        assertEquals(List.of(), new RecentWorlds(Optional.empty()).files());
    }

    @Test
    void whatIsForgottenIsNotThereAtTheNextStart() throws Exception {
        new RecentWorlds(memory).add(world("a.map"));
        memory.get().forget();
        assertEquals(Optional.empty(), first());
    }
}
