package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ListeningRequestTest {
    /** A key in brackets is within an order; a bar ends the call. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "*#, 1",
        "5*#, 1",
        "**#, 0",
        "***#, 0",
        "*5#, 0",
        "#*#, 0",
        "(*#), 0",
        "(#*0**)#, 0",
        "(#*0**)*#, 1",
        "*#*#, 2",
        "*#*#*#, 3",
        "#|*#, 1",
        "*|#, 0"
    })
    void aStarAloneAndAHashOutsideAnOrderAskToBeHeard(String keys, int requests) {
        ListeningRequest request = new ListeningRequest();
        boolean isOpen = false;
        int found = 0;
        for (char key : keys.toCharArray()) {
            if (key == '(' || key == ')') {
                isOpen = key == '(';
            } else if (key == '|') {
                request.reset();
            } else if (request.key(key, isOpen)) {
                found++;
            }
        }
        assertEquals(requests, found);
    }
}
