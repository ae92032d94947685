package simgsm.classroom.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class QuickDemoTest {
    @ParameterizedTest
    @CsvSource({
        "--demo, true",
        "--demo --lesson twelve-keys, true",
        "--lessons mine --demo --lesson corridor, true",
        "--demo --lessons=mine, true",
        "--lessons, false",
        "--lessons mine, false",
        "--demo --headless, false",
        "--demo --help, false",
        "--lesson twelve-keys --check right, false"
    })
    void aDemoWithAFolderOfLessonsHasWindowsToo(String words, boolean isDemo) {
        assertEquals(isDemo, QuickDemo.isDemo(words.split(" ")));
    }
}
