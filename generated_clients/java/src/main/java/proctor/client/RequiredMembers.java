/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client;

import com.google.gson.Gson;
import com.google.gson.JsonParseException;
import com.google.gson.TypeAdapter;
import com.google.gson.TypeAdapterFactory;
import com.google.gson.reflect.TypeToken;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonWriter;
import java.io.IOException;
import java.lang.reflect.Field;

/** Refuses a message without a member that the specification requires. */
final class RequiredMembers implements TypeAdapterFactory {
  @Override
  public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
    if (type.getRawType().getPackage() == null
        || !type.getRawType().getPackage().getName().equals("proctor.client.model")) {
      return null;
    }
    TypeAdapter<T> plain = gson.getDelegateAdapter(this, type);
    Field[] members = type.getRawType().getDeclaredFields();
    return new TypeAdapter<T>() {
      @Override
      public void write(JsonWriter out, T value) throws IOException {
        plain.write(out, value);
      }

      @Override
      public T read(JsonReader in) throws IOException {
        T message = plain.read(in);
        for (Field member : members) {
          if (message != null && member.isAnnotationPresent(javax.annotation.Nonnull.class)) check(message, member);
        }
        return message;
      }
    };
  }

  private static void check(Object message, Field member) throws IOException {
    try {
      member.setAccessible(true);
      if (member.get(message) == null) {
        throw new JsonParseException(message.getClass().getSimpleName() + " has no " + member.getName());
      }
    } catch (IllegalAccessException error) {
      throw new IOException(error);
    }
  }
}
