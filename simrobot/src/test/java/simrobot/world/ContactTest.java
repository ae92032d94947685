package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ContactTest {
    private final Contact near = new Contact(0.2, 1, 0);
    private final Contact far = new Contact(0.7, 0, 1);

    @Test
    void theSmallerFractionIsEarlier() {
        assertSame(near, near.earlier(far));
        assertSame(near, far.earlier(near));
    }

    @Test
    void ofTwoEqualOnesTheFirstCounts() {
        Contact same = new Contact(0.2, -1, 0);
        assertSame(near, near.earlier(same));
        assertSame(same, same.earlier(near));
    }

    @Test
    void anyContactIsEarlierThanNone() {
        Contact last = new Contact(1, 1, 0);
        assertSame(last, Contact.NONE.earlier(last));
        assertSame(last, last.earlier(Contact.NONE));
        assertSame(Contact.NONE, Contact.NONE.earlier(Contact.NONE));
        assertTrue(last.touches());
        assertFalse(Contact.NONE.touches());
    }
}
