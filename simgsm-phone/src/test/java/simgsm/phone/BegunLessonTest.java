package simgsm.phone;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.BufferedReader;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class BegunLessonTest {
    @Test
    void resultsAmongTheLessonsLinesArePassedOn() {
        List<List<String>> results = new ArrayList<>();
        String printed = "ready port=3003\nno event \"\n"
                + "lesson-result number=5550100 lesson=tones step=low result=pass tries=1 hints=0\n";
        BegunLesson.read(new BufferedReader(new StringReader(printed)), fields -> results.add(List.of(fields)));
        assertEquals(List.of(List.of("tones", "low", "pass", "1", "0")), results);
    }
}
