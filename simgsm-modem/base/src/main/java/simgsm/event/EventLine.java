package simgsm.event;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The line by which a console prints an event: the event's name, then its fields in order, as in
 * {@code released cause= text=cause.title}.
 *
 * <p>{@code KEY=} is the component or public method of that name; without one, the printer gives the value.
 * {@code KEY=PATH} is another component, or a component of a component. {@code KEY=PATH:N} rounds a number to N decimals.
 * A field in brackets is left out while it is empty.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
public @interface EventLine {
    String value();
}
