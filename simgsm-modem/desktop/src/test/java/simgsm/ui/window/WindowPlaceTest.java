package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WindowPlaceTest {
    @Test
    void aCornerMayComeWithOrWithoutASize() {
        assertEquals(new WindowPlace(-5, 20, 0, 0), WindowPlace.parse("-5,20"));
        assertEquals(new WindowPlace(0, 0, 800, 600), WindowPlace.parse("0,0,800,600"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"-5,20", "0,0,800,600"})
    void whatIsWrittenIsReadBack(String text) {
        assertEquals(text, WindowPlace.parse(text).toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "1", "1,2,3", "1,2,0,5", "1,2,-3,4", "1;2", "a,b", "1,2,3,4,5", "123456,0"})
    void anythingElseIsNoPlace(String text) {
        assertThrows(IllegalArgumentException.class, () -> WindowPlace.parse(text));
    }
}
